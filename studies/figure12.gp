
# To the left the reference bearing, to the right its bumps as high as those of the finite elements.
eval panels(2, 4, 3)
set xrange [20:82]
set yrange [0:1100]
set xtics 10
set ytics 200
set xlabel "displacement of the journal (µm)"
set ylabel "direct force (N)"
force(run, direction, branch) = is_run(run) && is_direction(direction) && on_branch(branch, 100) ? \
  column("force_direct_N") : NaN

do for [i = 1:4] {
  d = direction_degrees[i]
  set title panel(direction_names[i] . ", f = 0.1, height over the sleeve 0.508 mm")
  plot loops using (um * column("displacement_m")):(force("truss", d, "loading")) \
         with lines lw 2 dt 1 lc rgb blue title "truss, loading", \
       loops using (um * column("displacement_m")):(force("truss", d, "unloading")) \
         with lines lw 2 dt (8, 4) lc rgb blue title "truss, unloading", \
       loops using (um * column("displacement_m")):(force("frame", d, "loading")) every 4 \
         with points pt 7 ps 0.45 lc rgb red title "frame, loading", \
       loops using (um * column("displacement_m")):(force("frame", d, "unloading")) every 4 \
         with points pt 6 ps 0.5 lc rgb red title "frame, unloading", \
       loops using (um * column("displacement_m")):(force("frame-nonlinear", d, "loading")) every 4::2 \
         with points pt 9 ps 0.5 lc rgb green title "nonlinear frame, loading", \
       loops using (um * column("displacement_m")):(force("frame-nonlinear", d, "unloading")) every 4::2 \
         with points pt 8 ps 0.55 lc rgb green title "nonlinear frame, unloading", \
       keyentry with points pt 5 ps 0.4 lc rgb black title "finite elements, loading", \
       keyentry with points pt 4 ps 0.45 lc rgb black title "finite elements, unloading"
  unset key
  set title panel(direction_names[i] . ", f = 0.1, rise of the mid-surface 0.508 mm")
  plot loops using (um * column("displacement_m")):(force("truss-midsurface", d, "loading")) \
         with lines lw 2 dt 1 lc rgb blue title "truss, loading", \
       loops using (um * column("displacement_m")):(force("truss-midsurface", d, "unloading")) \
         with lines lw 2 dt (8, 4) lc rgb blue title "truss, unloading", \
       loops using (um * column("displacement_m")):(force("frame-midsurface", d, "loading")) every 4 \
         with points pt 7 ps 0.45 lc rgb red title "frame, loading", \
       loops using (um * column("displacement_m")):(force("frame-midsurface", d, "unloading")) every 4 \
         with points pt 6 ps 0.5 lc rgb red title "frame, unloading", \
       finite_elements using (um * column("displacement_m")):(force("finite-elements", d, "loading")) every 4::2 \
         with points pt 5 ps 0.4 lc rgb black title "finite elements, loading", \
       finite_elements using (um * column("displacement_m")):(force("finite-elements", d, "unloading")) every 4::2 \
         with points pt 4 ps 0.45 lc rgb black title "finite elements, unloading"
}
unset multiplot
