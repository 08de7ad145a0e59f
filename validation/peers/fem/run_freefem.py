"""FreeFEM on one mesh: run_freefem.py CHOLMOD|UMFPACK disc|open|rubber MESH.ff.msh (labels as in meshes.LABELS)."""

import json
import resource
import subprocess
import sys
import tempfile

from report import HEIGHT, LAMBDA, MU, PRESS, apparent_modulus

DISC = """
fespace Vh(Th, P2);
Vh u;
varf form(v, w) = int2d(Th, qforder=4)(2*pi*x*(dx(v)*dx(w) + dy(v)*dy(w))) OPEN + on(11, v=0.5) + on(12, v=-0.5);
matrix A = form(Vh, Vh, solver="SOLVER", sym=1);
real[int] b = form(0, Vh);
real t1 = clock();
u[] = A^-1 * b;
real t2 = clock();
real value = int2d(Th, qforder=4)(2*pi*x*(dx(u)^2 + dy(u)^2)) ENERGY;
"""
FAR = "int1d(Th, 13, qforder=6)(2*pi*x*(15.0/(x*x + y*y) - 0.2*(abs(y) > 4.999999))*{})"

RUBBER = """
fespace Vh(Th, [P2, P2]);
Vh [u, w];
real la = LAMBDA, mu = MU;
func real press() { return PRESS; }
macro e1(a) dx(a) //
macro e3(a) (a/x) //
macro volume(a, c) (dx(a) + a/x + dy(c)) //
macro shear(a, c) (dy(a) + dx(c)) //
varf form([u1, w1], [u2, w2]) = int2d(Th, qforder=4)(2*pi*x*(la*volume(u1, w1)*volume(u2, w2)
      + 2*mu*(e1(u1)*e1(u2) + e3(u1)*e3(u2) + dy(w1)*dy(w2)) + mu*shear(u1, w1)*shear(u2, w2)))
    + on(21, u1=0, w1=0) + on(22, u1=0, w1=PRESS) + on(31, u1=0);
matrix A = form(Vh, Vh, solver="SOLVER", sym=1);
real[int] b = form(0, Vh);
real t1 = clock();
u[] = A^-1 * b;
real t2 = clock();
real value = int2d(Th, qforder=4)(2*pi*x*(la*volume(u, w)^2 + 2*mu*(dx(u)^2 + (u/x)^2 + dy(w)^2) + mu*shear(u, w)^2));
"""

FRAME = """
verbosity = 0;
mesh Th = readmesh("FILE");
real t0 = clock();
BODY
real t3 = clock();
cout.precision(17);
cout << "RESULT " << Vh.ndof << " " << value << " " << t1 - t0 << " " << t2 - t1 << " " << t3 - t2 << endl;
"""


def program(solver, problem, file):
    body = RUBBER if problem == "rubber" else DISC
    far = "" if problem != "open" else "+ " + FAR
    for name, text in {
        "OPEN": far.format("v*w"),
        "ENERGY": far.format("u^2"),
        "SOLVER": solver,
        "PRESS": repr(-PRESS * HEIGHT),
        "LAMBDA": repr(LAMBDA),
        "MU": repr(MU),
    }.items():
        body = body.replace(name, text)
    return FRAME.replace("BODY", body).replace("FILE", file)


def main(solver, problem, file):
    with tempfile.NamedTemporaryFile("w", suffix=".edp") as script:
        script.write(program(solver, problem, file))
        script.flush()
        done = subprocess.run(["FreeFem++", "-nw", "-v", "0", script.name], capture_output=True, text=True)
    line = [l for l in done.stdout.splitlines() if l.startswith("RESULT")]
    if not line:
        sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
    unknowns, value, assemble, solve, evaluate = map(float, line[0].split()[1:])
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1000
    value = apparent_modulus(value) if problem == "rubber" else value
    total = assemble + solve + evaluate
    print(json.dumps({"unknowns": unknowns, "value": value, "seconds": total, "assemble": assemble, "solve": solve, "value_s": evaluate, "peak_mb": peak}))


if __name__ == "__main__":
    main(*sys.argv[1:])
