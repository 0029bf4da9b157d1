# Tables, picture and style of all studies: the head of every picture.gp. "gnuplot picture.gp" draws the picture again.
if (!exists("picture")) picture = "picture.svg"
if (!exists("loops")) loops = "loops.csv"
if (!exists("quantities")) quantities = "quantities.csv"
if (!exists("loads")) loads = "loads.csv"
if (!exists("heights")) heights = "heights.csv"
if (!exists("foils")) foils = "foils.csv"
if (!exists("contacts")) contacts = "contacts.csv"
if (!exists("finite_elements")) finite_elements = "finite_elements.csv"

set datafile separator comma
set datafile columnheaders
set datafile missing NaN  # rows that a curve does not want: it goes on at the next
set encoding utf8
set minussign
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb "#d9d9d9" dt 1
set key spacing 1.1 Left reverse

# Colours differ in grey as well; dashes and points tell them apart where there is no colour.
black = "#000000"; blue = "#0b4f9c"; red = "#b8420f"; green = "#2f8f4e"; grey = "#8c8c8c"

um = 1e6

# Opens a picture of panels, with one legend of so many rows above them: eval panels(columns, rows, legend). In print,
# 190 mm wide, its type has 7.4 pt, and four rows fill a page. The first panel has the legend; after it: unset key.
picture_width = 875.0
panel_height(rows) = rows == 4 ? 250.0 : 300.0
picture_height(rows, legend) = rows * panel_height(rows) + 24 * legend
panels(columns, rows, legend) = sprintf("set terminal svg size %d, %d font 'DejaVu Sans,12' background 'white' enhanced; ", \
                                        picture_width, picture_height(rows, legend)) . \
  sprintf("set output picture; set multiplot layout %d, %d margins screen %g, %g, %g, %g ", rows, columns, \
          76.0 / picture_width, 1 - 15.0 / picture_width, \
          55.0 / picture_height(rows, legend), 1 - (28.0 + 24 * legend) / picture_height(rows, legend)) . \
  sprintf("spacing screen %g, %g; ", 81.0 / picture_width, 88.0 / picture_height(rows, legend)) . \
  sprintf("set key at screen 0.5, %g center top vertical maxrows %d samplen 2.5 width 1", 1 - 6.0 / picture_height(rows, legend), legend)

# The title of a panel, behind its letter: set title panel("+X").
panel_number = 0
panel(text) = (panel_number = panel_number + 1, \
               sprintf("{/:Bold (%s)} %s", "abcdefghijklmnopqrstuvwxyz"[panel_number:panel_number], text))
set title offset 0, -0.7
set xlabel offset 0, 0.5
set ylabel offset 1.2, 0

# Rows of a table: of a run, a direction, a branch. "unloading" begins with the turning point.
is_run(run) = strcol("run") eq run
is_direction(degrees) = abs(column("direction_deg") - degrees) < 1e-6
on_branch(branch, steps) = strcol("branch") eq branch || (branch eq "unloading" && column("increment") == steps)

# The four directions of the reference case, each with its own line.
array direction_names[4] = ["+X", "−X", "+Y", "−Y"]
array direction_degrees[4] = [0, 180, 90, 270]
set style line 101 lw 2 dt 1 pt 7 ps 0.6 lc rgb blue
set style line 102 lw 2 dt (6, 4) pt 6 ps 0.7 lc rgb red
set style line 103 lw 2 dt (2, 3) pt 9 ps 0.7 lc rgb green
set style line 104 lw 2 dt (10, 3, 2, 3) pt 4 ps 0.6 lc rgb black
