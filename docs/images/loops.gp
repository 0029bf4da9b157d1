# Loops of the reference bearing. After `make demo`, in the top folder:
#   gnuplot docs/images/loops.gp
set terminal svg size 860,470 font "DejaVu Sans,15" background "white" enhanced
set output "docs/images/loops.svg"
set datafile separator comma
set key top left reverse Left samplen 3 spacing 1.2
set grid lc rgb "#dddddd"
set border 3
set tics nomirror
set xlabel "displacement of the journal (µm)"
set ylabel "direct force (N)"
set xrange [0:80]
set yrange [0:*]
csv = "results/demo/cycle.csv"
# Displacement in column 4, direct force in column 9, direction in column 1. One curve runs up and back down.
of(direction) = sprintf("< awk -F, '$1 == %d {print $4 * 1e6 \",\" $9}' %s", direction, csv)
plot of(90)  with lines lw 2.5 dt 1 lc rgb "#0b57a4" title "+Y: bumps 2 to 12", \
     of(180) with lines lw 2.5 dt 2 lc rgb "#a8330b" title "−X: towards the weld", \
     of(0)   with lines lw 2.5 dt 4 lc rgb "#1a7f37" title "+X: middle of the foil", \
     of(270) with lines lw 2.5 dt 5 lc rgb "#7a3fa0" title "−Y: free-end side"
