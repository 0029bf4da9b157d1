
eval panels(2, 2, 1)
set xrange [-80:80]
set yrange [-900:900]
set xtics 20
set ytics 300
set xzeroaxis lw 0.8 lc rgb black dt 1

# One axis for both senses of a direction: to the left the push towards minus.
minus(degrees) = degrees >= 180 ? -1 : 1
displacement(degrees) = minus(degrees) * um * column("displacement_m")
force(run, degrees, branch) = is_run(run) && is_direction(degrees) && on_branch(branch, 100) ? \
  minus(degrees) * column("force_direct_N") : NaN

do for [axis in "X Y"] {
  do for [friction in "friction frictionless"] {
    array direction[2]
    direction[1] = axis eq "X" ? 0 : 90
    direction[2] = direction[1] + 180
    present = "present-" . friction
    former = "former-" . friction
    set title panel(axis . (friction eq "friction" ? ", friction 0.1" : ", no friction"))
    set xlabel "displacement of the journal along " . axis . " (µm)"
    set ylabel "direct force (N)"
    plot for [i = 1:2] loops using (displacement(direction[i])):(force(present, direction[i], "loading")) \
           with lines lw 2 dt 1 lc rgb blue title i == 1 ? "this model, loading" : "", \
         for [i = 1:2] loops using (displacement(direction[i])):(force(present, direction[i], "unloading")) \
           with lines lw 2 dt (8, 4) lc rgb blue title i == 1 ? "this model, unloading" : "", \
         for [i = 1:2] loops using (displacement(direction[i])):(force(former, direction[i], "loading")) \
           every 4 with points pt 7 ps 0.4 lc rgb red title i == 1 ? "Le Lez (2007), loading" : ""
    unset key
  }
}
unset multiplot
