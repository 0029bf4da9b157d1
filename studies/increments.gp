
# Deviations from what following events gives.
eval panels(2, 1, 1)
set xlabel "increments each way"
set ylabel "deviation from the limit (%)"
set format y "%g"
array columns[2] = ["max_force_N", "loop_energy_J"]
array labels[2] = ["force at full displacement", "loop energy"]
array limit[4]
deviation(i, name) = strcol("run") ne "events" && is_direction(direction_degrees[i]) ? 100 * abs(column(name) / limit[i] - 1) : NaN
do for [j = 1:2] {
  unset logscale
  set autoscale
  do for [i = 1:4] {
    stats quantities using (is_run("events") && is_direction(direction_degrees[i]) ? column(columns[j]) : NaN) nooutput
    limit[i] = STATS_max
  }
  set logscale xy
  set xrange [4:1200]
  set yrange [1e-3:100]
  set title panel(labels[j])
  plot for [i = 1:4] quantities using "steps":(deviation(i, columns[j])) with linespoints ls 100 + i title direction_names[i]
  unset key
}
unset multiplot
