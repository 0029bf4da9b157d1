
eval panels(2, 4, 1)
set xrange [0.3:26.7]
set yrange [0:200]
set xtics 2
set ytics 50
set xlabel "bump, counted from the weld"
set ylabel "load on the bump (N)"
load(run, direction) = is_run(run) && is_direction(direction) ? column("bump_load_N") : NaN

do for [i = 1:4] {
  do for [friction in "friction frictionless"] {
    set title panel(direction_names[i] . (friction eq "friction" ? ", friction 0.1" : ", no friction"))
    plot loads using "bump":(load("present-" . friction, direction_degrees[i])) with linespoints pt 7 ps 0.55 lw 1.5 dt 1 lc rgb blue \
           title "this model", \
         loads using "bump":(load("former-" . friction, direction_degrees[i])) with linespoints pt 6 ps 0.9 lw 1.5 dt (3, 3) lc rgb red \
           title "Le Lez (2007)"
    unset key
  }
}
unset multiplot
