# Writes one packing of spheres for four programs: page.md for nineball, in.txt and data.txt for LAMMPS, liggghts.txt and
# liggghts-data.txt for LIGGGHTS, and yade.txt, which yade.py reads together with data.txt, for YADE.
#
#   awk -v n=SIDE -v kind=lattice|random|rows -v law=linear|hertz|exact -v cycles=CYCLES -v folder=FOLDER -f packing.awk
#
# n rows of n spheres on a triangular lattice whose neighbours overlap by 0.5 % of the radius; the outermost are fixed.
# `random`: the radii differ by up to 0.2 %, every tenth place is empty and the numbers are shuffled, so that the number of
# contacts differs between particles without a pattern. `rows`: the same, numbered row by row. Dashpots are on. All programs get the same step. The constants of
# LAMMPS and LIGGGHTS are those that give the same stiffness and, for the overlap of the lattice, the same damping. In two
# dimensions LIGGGHTS has discs of unit thickness; they get the masses of the spheres, but the moments of inertia of discs.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
function next_random() { seed = (seed * 1103 + 12345) % 65536; return seed / 65536 }
# Writes the spheres for LAMMPS, or the discs of the same masses for LIGGGHTS.
function data(file, discs) {
  printf "packing\n\n%d atoms\n2 atom types\n%.9g %.9g xlo xhi\n%.9g %.9g ylo yhi\n%.9g %.9g zlo zhi\n\nAtoms\n\n", count, -2 * R, d * n + 2 * R, -2 * R, d * n + 2 * R, -R / 10, R / 10 >file
  for (k = 1; k <= count; k++) {
    p = order[k]; r = sprintf("%.6g", radius[p])
    printf "%d %d %.8g %.12g %.8g %.8g 0\n", k, 1 + fixed[p], 2 * r, discs ? density * 4 / 3 * r : density, x[p], y[p] >file
  }
}
function property(name, value) { printf "fix %s all property/global %s peratomtypepair 2%s\n", name, name, sprintf(" %.9g %.9g %.9g %.9g", value, value, value, value) >input }
# Writes the end of the input, which is the same for LAMMPS and LIGGGHTS.
function run_lines() {
  print "pair_coeff * *\ngroup fixed type 2\ngroup free type 1\nneigh_modify exclude group fixed fixed" >input
  print "fix move free nve/sphere\nfix plane all enforce2d\nfix hold fixed freeze" >input
  printf "timestep %.9g\nthermo_modify norm no\nthermo 1000000000\nrun %d\n", step, cycles >input
}
function place(i, j) { x[++count] = d * (i + j % 2 / 2); y[count] = d * sqrt(3) / 2 * j }
BEGIN {
  seed = 12345; pi = 3.14159265358979
  R = 0.01; d = 1.995 * R; density = 2000; kn = 1e7; ks = 8e6; young = 70e9; poisson = 0.25; friction = 0.5; ratio = 0.05
  mass = density * 4 / 3 * pi * R ^ 3
  effective = young / (2 * (1 - poisson ^ 2)); shear = young / (2 * (1 + poisson)) / (2 * (2 - poisson))
  exact = law == "exact"; if (exact) law = "hertz" # the law `shear mindlin_deresiewicz`, which LAMMPS does not have
  stiffness = law == "hertz" ? 2 * effective * sqrt(R / 2 * (2 * R - d)) : kn
  step = 0.05 * sqrt(mass / stiffness)
  for (j = 0; j < n; j++)
    for (i = 0; i < n; i++) {
      edge = i == 0 || j == 0 || i == n - 1 || j == n - 1
      chance = next_random()
      if (kind != "lattice" && !edge && chance < 0.1) continue
      place(i, j); fixed[count] = edge; radius[count] = R * (kind != "lattice" ? 0.998 + 0.004 * next_random() : 1)
    }
  for (k = 1; k <= count; k++) order[k] = k
  for (k = count; kind == "random" && k > 1; k--) {
    other = 1 + int((next_random() + next_random() / 65536) * k); swap = order[k]; order[k] = order[other]; order[other] = swap
  }

  page = folder "/page.md"
  print "# Packing\n\n```scene" >page
  print "material m density " density " kg/m3 kn " kn " N/m ks " ks " N/m young " young " Pa poisson " poisson " friction " friction >page
  print "normal " (law == "hertz" ? "hertz" : "linear") "\nshear " (exact ? "mindlin_deresiewicz" : law == "hertz" ? "mindlin" : "linear") >page
  print "damping ratio " ratio >page
  for (k = 1; k <= count; k++) {
    p = order[k]
    printf "sphere %.8g m %.8g m radius %.6g m m%s\n", x[p], y[p], radius[p], fixed[p] ? " fixed" : "" >page
  }
  printf "step %.9g s\nstage run\nrecord none\ncycles %d\n```\n", step, cycles >page

  data(folder "/data.txt", 0)
  data(folder "/liggghts-data.txt", 1)
  # half the mass is the reduced mass; the dashpot of LAMMPS is gamma M*, times the root of R* alpha with Hertz's law
  gamma = 2 * ratio * sqrt(stiffness / (mass / 2)); tangential = gamma * sqrt(0.8)
  root = sqrt(R / 2 * (2 * R - d))
  normal = law == "hertz" ? gamma / root : gamma; shearing = law == "hertz" ? tangential / root : tangential

  input = folder "/in.txt"
  print "atom_style sphere\nunits si\ndimension 2\nboundary f f p\nnewton off\ncomm_modify vel yes\nread_data data.txt" >input
  print "neighbor " R / 10 " bin\nneigh_modify delay 0 every 1 check yes" >input
  if (law == "hertz") print "pair_style gran/hertz/history", 4 / 3 * effective, 8 * shear, normal, shearing, friction, 1 >input
  else print "pair_style gran/hooke/history", kn, ks, normal, shearing, friction, 1 >input
  run_lines()

  input = folder "/liggghts.txt"
  print "atom_style granular\natom_modify map array\nunits si\ndimension 2\nboundary f f p\nnewton off\ncommunicate single vel yes" >input
  print "read_data liggghts-data.txt\nneighbor " R / 10 " bin\nneigh_modify delay 0 every 1 check yes" >input
  property("kn", law == "hertz" ? 4 / 3 * effective : kn); property("kt", law == "hertz" ? 8 * shear : ks)
  property("gamman", normal); property("gammat", shearing); property("coefficientFriction", friction)
  print "pair_style gran model " (law == "hertz" ? "hertz" : "hooke") "/stiffness tangential history" >input
  run_lines()

  input = folder "/yade.txt"
  printf "law %s\ncycles %d\nstep %.9g\nskin %.9g\nfriction %.9g\ndensity %.9g\n", law, cycles, step, R / 10, friction, density >input
  if (law == "hertz") printf "young %.9g\npoisson %.9g\nratio %.9g\n", young, poisson, ratio >input
  else printf "kn %.9g\nks %.9g\ncn %.9g\ncs %.9g\n", kn, ks, gamma * mass / 2, tangential * mass / 2 >input
}
