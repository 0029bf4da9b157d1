
eval panels(2, 2, 1)
set xrange [-11:51]
set xtics 10
set xlabel "radial clearance (µm)"
at(degrees, scale, name) = is_direction(degrees) ? scale * column(name) : NaN
array columns[4] = ["max_force_N", "initial_journal_load_N", "loop_energy_J", "tangent_stiffness_loading_N_per_m"]
array labels[4] = ["force at full displacement (N)", "load of the centred journal (N)", "loop energy (mJ)", \
                   "tangent stiffness, loading (MN/m)"]
array scales[4] = [1, 1, 1000, 1e-6]

do for [j = 1:4] {
  set yrange [0:*]
  set title panel("")
  set ylabel labels[j]
  plot for [i = 1:4] quantities using "radial_clearance_um":(at(direction_degrees[i], scales[j], columns[j])) with linespoints \
    ls 100 + i title direction_names[i]
  unset key
}
unset multiplot
