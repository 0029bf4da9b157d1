
eval panels(3, 4, 2)

# Six bearings: force against displacement, and below it the heights of the bumps and of the journal's surface.
bearing(i) = sprintf("bearing%d", i)
is_of(run) = strstrt(strcol("run"), run) > 0
force(run, branch) = is_of(run) && on_branch(branch, 100) ? column("force_direct_N") : NaN
height(run, name) = is_of(run) ? um * column(name) : NaN

do for [row = 0:1] {
  set xrange [0:80]
  set yrange [-50:1100]
  set xtics 20
  set ytics 200
  set xlabel "displacement to +X (µm)"
  set ylabel "direct force (N)"
  do for [i = 3 * row + 1:3 * row + 3] {
    set title panel(sprintf("bearing %d", i))
    plot loops using (um * column("displacement_m")):(force("perfect", "loading")) with lines lw 1.2 dt 1 lc rgb grey \
           title "no height errors", \
         loops using (um * column("displacement_m")):(force("perfect", "unloading")) with lines lw 1.2 dt (6, 4) lc rgb grey notitle, \
         loops using (um * column("displacement_m")):(force(bearing(i), "loading")) with lines lw 2 dt 1 lc rgb blue \
           title "loading", \
         loops using (um * column("displacement_m")):(force(bearing(i), "unloading")) with lines lw 2 dt (8, 4) lc rgb blue \
           title "unloading", \
         keyentry with boxes fs solid 1 border lc rgb black fc rgb "#d4d4d4" title "bumps", \
         keyentry with lines lw 1.5 dt (6, 4) lc rgb black title "design", \
         keyentry with lines lw 1.5 dt (2, 3) lc rgb red title "journal centred", \
         keyentry with lines lw 2 dt 1 lc rgb red title "journal pushed"
    unset key
  }
  set xrange [0:27]
  set yrange [440:640]
  set boxwidth 0.9 absolute
  set xtics 1, 5
  set ytics 40
  set xlabel "bump, counted from the weld"
  set ylabel "height over the sleeve (µm)"
  do for [i = 3 * row + 1:3 * row + 3] {
    set title panel(sprintf("bearing %d", i))
    plot heights using "bump":(height(bearing(i), "height_m")) with boxes fs solid 1 border lc rgb black fc rgb "#d4d4d4" \
           notitle, \
         heights using "bump":(height("perfect", "height_m")) with lines lw 1.5 dt (6, 4) lc rgb black \
           notitle, \
         heights using "bump":(height(bearing(i), "journal_centred_m")) with lines lw 1.5 dt (2, 3) lc rgb red \
           notitle, \
         heights using "bump":(height(bearing(i), "journal_pushed_m")) with lines lw 2 dt 1 lc rgb red \
           notitle
  }
}
unset multiplot
