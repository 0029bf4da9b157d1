
eval panels(2, 2, 1)
set xrange [-0.01:0.51]
set xtics 0.1
set xlabel "friction coefficient"
at(degrees, scale, name) = is_direction(degrees) ? scale * column(name) : NaN
array columns[4] = ["max_force_N", "loop_energy_J", "loss_factor", "cross_force_at_max_N"]
array labels[4] = ["force at full displacement (N)", "loop energy (mJ)", "loss factor", "cross force (N)"]
array scales[4] = [1, 1000, 1, 1]

do for [j = 1:4] {
  set yrange [(j == 4 ? -200 : 0):*]
  set title panel("")
  set ylabel labels[j]
  plot for [i = 1:4] quantities using "coefficient":(at(direction_degrees[i], scales[j], columns[j])) with linespoints ls 100 + i \
    title direction_names[i]
  unset key
}
unset multiplot
