
eval panels(2, 2, 1)
set xrange [0.5:6.5]
set xtics 1
set xlabel "bearing"
number(run) = strstrt(run, "perfect") == 1 ? NaN : substr(run, strstrt(run, "bearing") + 7, strstrt(run, "bearing") + 7) + 0
of(scatter, model, scale, name) = strstrt(strcol("run"), scatter) == 1 && strstrt(strcol("run"), model) > 0 ? \
  scale * column(name) : NaN
array columns[2] = ["max_force_N", "loop_energy_J"]
array labels[2] = ["force at full displacement (N)", "loop energy (mJ)"]
array scales[2] = [1, 1000]
array perfect[2]

do for [j = 1:2] {
  set autoscale
  stats quantities using (strcol("run") eq "perfect-truss" ? scales[j] * column(columns[j]) : NaN) nooutput
  perfect[j] = STATS_max
}
do for [j = 1:2] {
  do for [scatter in "10 20"] {
    family = "scatter" . scatter
    set title panel("bump heights scattered by " . scatter . " µm")
    set ylabel labels[j]
    set xrange [0.5:6.5]
    set yrange [0:(j == 1 ? 1200 : 12)]
    plot perfect[j] with lines lw 1.5 dt (2, 3) lc rgb black title "truss, no height errors", \
         quantities using (number(strcol("run"))):(of(family, "truss", scales[j], columns[j])) with points ls 101 ps 1 \
           title "truss", \
         quantities using (number(strcol("run"))):(of(family, "frame", scales[j], columns[j])) with points ls 102 ps 1.3 \
           title "frame"
    unset key
  }
}
unset multiplot
