
# A row for each position of the journal: crests, top foil and journal unwrapped; gaps and closed contacts; and all of
# it round the bearing. The last row counts closed contacts along the whole path.
eval panels(3, 6, 3)
at(k, name) = column("increment") == k ? um * column(name) : NaN
mark(k, interface, state, height) = column("increment") == k && strstrt(strcol("state_" . interface), state) == 1 ? height : NaN

# Round view, not to scale: what is higher than 440 µm over the sleeve stands on the outer circle, threefold.
radius_of(height) = 1000 - 3 * (height - 440)
x_of(k, height) = (at(k, "bump") > 0 ? 1 : NaN) * radius_of(height) * cos(pi / 180 * column("phi_deg"))
y_of(k, height) = (at(k, "bump") > 0 ? 1 : NaN) * radius_of(height) * sin(pi / 180 * column("phi_deg"))

set boxwidth 0.9 absolute
array increments[5] = [0, 25, 50, 75, 100]
do for [i = 1:5] {
  k = increments[i]
  set border 3
  set grid
  set size noratio
  set xrange [0:27]
  set xtics nomirror 1, 5
  set xlabel "bump, counted from the weld"

  set yrange [440:640]
  set ytics nomirror 440, 40, 640
  set ylabel "height over the sleeve (µm)"
  set title panel(sprintf("journal at %.1f µm", 79.5 * k / 100))
  plot foils using "bump":(at(k, "crest_height_m")) with boxes fs solid 1 border lc rgb black fc rgb "#d4d4d4" title "crests", \
       foils using "bump":(at(k, "top_foil_height_m")) with linespoints pt 7 ps 0.35 lw 1.8 lc rgb blue title "top foil", \
       foils using "bump":(at(k, "journal_height_m")) with lines lw 1.8 dt (6, 4) lc rgb red title "journal", \
       keyentry with linespoints pt 4 ps 0.5 lw 1 lc rgb red title "journal/top foil", \
       keyentry with linespoints pt 6 ps 0.5 lw 1 lc rgb blue title "top foil/bump", \
       keyentry with linespoints pt 8 ps 0.6 lw 1 lc rgb green title "bump/sleeve", \
       keyentry with points pt 7 ps 0.7 lc rgb black title "stick", \
       keyentry with points pt 9 ps 0.7 lc rgb black title "slip to the free end", \
       keyentry with points pt 11 ps 0.7 lc rgb black title "slip to the weld"
  unset key

  set yrange [-45:135]
  set ytics nomirror ("0" 0, "20" 20, "40" 40, "60" 60, "80" 80, "100" 100, "journal" -13, "bump" -25, "sleeve" -37)
  unset ylabel
  set label 1 "gap (µm)" at graph -0.03, 1.0 right
  set title panel("gaps and closed contacts")
  plot foils using "bump":(at(k, "gap_journal_top_m")) with linespoints pt 4 ps 0.5 lw 1 lc rgb red notitle, \
       foils using "bump":(at(k, "gap_top_bump_m")) with linespoints pt 6 ps 0.5 lw 1 lc rgb blue notitle, \
       foils using "bump":(at(k, "gap_bump_sleeve_m")) with linespoints pt 8 ps 0.6 lw 1 lc rgb green notitle, \
       for [j = 1:3] foils using "bump":(mark(k, word("journal_top top_bump bump_sleeve", j), "stick", -1 - 12 * j)) \
         with points pt 7 ps 0.7 lc rgb black notitle, \
       for [j = 1:3] foils using "bump":(mark(k, word("journal_top top_bump bump_sleeve", j), "slip_forward", -1 - 12 * j)) \
         with points pt 9 ps 0.7 lc rgb black notitle, \
       for [j = 1:3] foils using "bump":(mark(k, word("journal_top top_bump bump_sleeve", j), "slip_backward", -1 - 12 * j)) \
         with points pt 11 ps 0.7 lc rgb black notitle
  unset label 1

  unset border
  unset grid
  unset xtics
  unset ytics
  set xlabel ""
  set size ratio -1
  set xrange [-1050:1050]
  set yrange [-1050:1050]
  set title panel("round the bearing")
  plot sample [t = 0:2 * pi] "+" using (1000 * cos(t)):(1000 * sin(t)) with lines lw 1 lc rgb black, \
       foils using (x_of(k, 440)):(y_of(k, 440)):(x_of(k, at(k, "crest_height_m")) - x_of(k, 440)): \
         (y_of(k, at(k, "crest_height_m")) - y_of(k, 440)) with vectors nohead lw 6 lc rgb "#bdbdbd", \
       foils using (x_of(k, at(k, "top_foil_height_m"))):(y_of(k, at(k, "top_foil_height_m"))) with lines lw 1.8 lc rgb blue, \
       foils using (x_of(k, at(k, "journal_height_m"))):(y_of(k, at(k, "journal_height_m"))) with lines lw 1.8 dt (6, 4) lc rgb red
}

set border 3
set grid
set xtics nomirror 0, 20, 80
set ytics nomirror 0, 5, 25
set size noratio
set xrange [0:80]
set yrange [0:26]
set xlabel "displacement to +X (µm)"
set ylabel "closed contacts"
count(branch, interface) = on_branch(branch, 100) ? column("closed_" . interface) : NaN
# Marks as in the legend, here and there along the lines.
set style line 1 lw 1.5 dt 1 pt 4 ps 0.5 pi 12 lc rgb red
set style line 2 lw 1.5 dt 1 pt 6 ps 0.5 pi 12 lc rgb blue
set style line 3 lw 1.5 dt 1 pt 8 ps 0.6 pi 12 lc rgb green
set style line 11 lw 1.5 dt (3, 3) pt 4 ps 0.5 pi 12 lc rgb red
set style line 12 lw 1.5 dt (3, 3) pt 6 ps 0.5 pi 12 lc rgb blue
set style line 13 lw 1.5 dt (3, 3) pt 8 ps 0.6 pi 12 lc rgb green
interface(j) = word("journal_top top_bump bump_sleeve", j)
do for [branch in "loading unloading"] {
  set title panel(branch)
  plot for [j = 1:3] contacts using (um * column("displacement_m")):(count(branch, interface(j))) with linespoints ls j notitle
}

# Since the assembly.
set title panel("opened (solid), closed (dashed)")
set xrange [0:200]
set ytics nomirror 0, 10
set xtics nomirror 0, 50, 200
set xlabel "increment (100 is the turning point)"
set ylabel "changes, summed up"
set yrange [0:45]
plot for [j = 1:3] contacts using "increment":(column("newly_open_" . interface(j))) smooth cumulative with linespoints ls j notitle, \
     for [j = 1:3] contacts using "increment":(column("newly_closed_" . interface(j))) smooth cumulative with linespoints ls (10 + j) notitle
unset multiplot
