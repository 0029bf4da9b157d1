
eval panels(2, 1, 1)
set xrange [0.5:6.5]
set yrange [-3:43]
set xtics 1
set ytics 10
set xlabel "bearing"
set ylabel "estimated clearance to +X (µm)"
number(run) = run eq "perfect" ? NaN : run[strlen(run):strlen(run)] + 0
clearance(scatter, name) = strstrt(strcol("run"), scatter) == 1 ? um * column(name) : NaN
design = 31.8

do for [scatter in "10 20"] {
  set title panel("bump heights scattered by " . scatter . " µm")
  family = "scatter" . scatter
  plot design with lines lw 1.5 dt (2, 3) lc rgb black title "design, 31.8 µm", \
       quantities using (number(strcol("run"))):(clearance(family, "clearance_5N_m")) with points pt 7 ps 0.9 lc rgb blue title "at 5 N", \
       quantities using (number(strcol("run"))):(clearance(family, "clearance_10N_m")) with points pt 6 ps 1.1 lc rgb red title "at 10 N"
  unset key
}
unset multiplot
