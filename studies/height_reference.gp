
eval panels(2, 2, 2)
set xrange [30:82]
set yrange [0:1100]
set xtics 10
set ytics 250
set xlabel "displacement of the journal (µm)"
set ylabel "direct force (N)"
force(run, direction, branch) = is_run(run) && is_direction(direction) && on_branch(branch, 100) ? \
  column("force_direct_N") : NaN

do for [i = 1:4] {
  set title panel(direction_names[i])
  plot for [branch in "loading unloading"] loops \
         using (um * column("displacement_m")):(force("present-friction-overall", direction_degrees[i], branch)) \
         with lines lw 2 dt 1 lc rgb blue title branch eq "loading" ? "height over the sleeve, friction 0.1" : "", \
       for [branch in "loading unloading"] loops \
         using (um * column("displacement_m")):(force("present-friction-midsurface", direction_degrees[i], branch)) \
         with lines lw 2 dt (8, 4) lc rgb red title branch eq "loading" ? "rise of the mid-surface, friction 0.1" : "", \
       loops using (um * column("displacement_m")):(force("present-frictionless-overall", direction_degrees[i], "loading")) \
         with lines lw 2 dt (2, 3) lc rgb black title "height over the sleeve, no friction", \
       loops using (um * column("displacement_m")):(force("present-frictionless-midsurface", direction_degrees[i], "loading")) \
         every 4 with points pt 6 ps 0.5 lc rgb black title "rise of the mid-surface, no friction"
  unset key
}
unset multiplot
