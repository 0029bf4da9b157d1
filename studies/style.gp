# Tables, picture and style of all studies: the head of every picture.gp. "gnuplot picture.gp" draws the picture again.
if (!exists("picture")) picture = "picture.svg"
if (!exists("loops")) loops = "loops.csv"
if (!exists("quantities")) quantities = "quantities.csv"
if (!exists("loads")) loads = "loads.csv"
if (!exists("heights")) heights = "heights.csv"
if (!exists("foils")) foils = "foils.csv"
if (!exists("contacts")) contacts = "contacts.csv"

set datafile separator comma
set datafile columnheaders
set encoding utf8
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb "#d9d9d9" dt 1
set key samplen 2.5 spacing 1.1 Left reverse

# Colours differ in grey as well; dashes and points tell them apart where there is no colour.
black = "#000000"; blue = "#0b4f9c"; red = "#b8420f"; green = "#2f8f4e"; grey = "#8c8c8c"

um = 1e6
column_width = 430  # of one panel
row_height = 300

# Rows of a table: of a run, a direction, a branch. "unloading" begins with the turning point.
is_run(run) = strcol("run") eq run
is_direction(degrees) = abs(column("direction_deg") - degrees) < 1e-6
on_branch(branch, steps) = strcol("branch") eq branch || (branch eq "unloading" && column("increment") == steps)
