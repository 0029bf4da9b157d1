
eval panels(2, 2, 1)
set xrange [0.3:26.7]
set yrange [0:340]
set xtics 2
set ytics 100
set xlabel "bump, counted from the weld"
set ylabel "load on the bump (N)"
load(run, direction) = is_run(run) && is_direction(direction) ? column("bump_load_N") : NaN

do for [i = 1:4] {
  set title panel(direction_names[i] . ", friction 0.1")
  plot loads using "bump":(load("top_foil_0.0102mm", direction_degrees[i])) with linespoints ls 103 \
         title "top foil 0.0102 mm thick", \
       loads using "bump":(load("top_foil_0.102mm", direction_degrees[i])) with linespoints ls 101 title "0.102 mm (design)", \
       loads using "bump":(load("top_foil_1.02mm", direction_degrees[i])) with linespoints ls 102 title "1.02 mm"
  unset key
}
unset multiplot
