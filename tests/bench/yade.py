# Runs a packing in YADE: yade -n -x -j1 yade.py, in a folder with yade.txt and data.txt of packing.awk. The program
# exits after the run. Spheres move in the plane and rotate about the normal of the plane.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
from math import atan

text = dict(line.split() for line in open("yade.txt"))
law = text.pop("law")
value = {name: float(word) for name, word in text.items()}
common = {"frictionAngle": atan(value["friction"]), "density": value["density"]}
if law == "linear":  # the stiffness of a contact is that of the two particles in series
    material = ViscElMat(**{name: 2 * value[name] for name in ("kn", "ks", "cn", "cs")}, **common)
    functors = [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]
else:
    material = FrictMat(young=value["young"], poisson=value["poisson"], **common)
    functors = [Ip2_FrictMat_FrictMat_MindlinPhys(betan=value["ratio"], betas=value["ratio"])], [Law2_ScGeom_MindlinPhys_Mindlin()]
O.materials.append(material)
for line in open("data.txt"):
    word = line.split()
    if len(word) == 7:
        fixed = word[1] == "2"
        body = sphere((float(word[4]), float(word[5]), 0), float(word[2]) / 2, material=material, fixed=fixed)
        if not fixed:
            body.state.blockedDOFs = "zXY"
        O.bodies.append(body)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=value["skin"] / 2),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], *functors),
    NewtonIntegrator(damping=0),
]
O.dt = value["step"]
O.run(int(value["cycles"]), True)
