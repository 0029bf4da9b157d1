
eval panels(2, 2)
set xrange [20:82]
set yrange [0:1100]
set xtics 10
set ytics 200
set xlabel "displacement of the journal (µm)"
set ylabel "direct force (N)"
set key top left
force(run, direction, branch) = is_run(run) && is_direction(direction) && on_branch(branch, 100) ? \
  column("force_direct_N") : NaN

do for [i = 1:4] {
  set title direction_names[i] . ", friction 0.1"
  plot loops using (um * column("displacement_m")):(force("truss", direction_degrees[i], "loading")) \
         with lines lw 2 dt 1 lc rgb blue title "truss, loading", \
       loops using (um * column("displacement_m")):(force("truss", direction_degrees[i], "unloading")) \
         with lines lw 2 dt (8, 4) lc rgb blue title "truss, unloading", \
       loops using (um * column("displacement_m")):(force("frame", direction_degrees[i], "loading")) every 3 \
         with points pt 7 ps 0.45 lc rgb red title "frame, loading", \
       loops using (um * column("displacement_m")):(force("frame", direction_degrees[i], "unloading")) every 3 \
         with points pt 6 ps 0.5 lc rgb red title "frame, unloading", \
       loops using (um * column("displacement_m")):(force("frame-nonlinear", direction_degrees[i], "loading")) every 3 \
         with points pt 9 ps 0.5 lc rgb green title "nonlinear frame, loading", \
       loops using (um * column("displacement_m")):(force("frame-nonlinear", direction_degrees[i], "unloading")) every 3 \
         with points pt 8 ps 0.55 lc rgb green title "nonlinear frame, unloading"
}
unset multiplot
