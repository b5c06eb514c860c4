svs --enable
source agent.soar
!svs add lamp world b 2.0 p 2 -3 4 r 1 1.34 1.5708
!svs add hero world b 1.75 p -1.59 3.5 -3.25
!svs add crate world v -0.83 -1.02 -0.56 -0.83 -1.02 0.56 -0.83 1.02 -0.56 -0.83 1.02 0.56 0.83 -1.02 -0.56 0.83 -1.02 0.56 0.83 1.02 -0.56 0.83 1.02 0.56 p -2 -1 -2.04 r 1.5708 0 0.5
!svs add spot world v -0.52 -0.99 -0.63 -0.52 -0.99 0.63 -0.52 0.99 -0.63 -0.52 0.99 0.63 0.52 -0.99 -0.63 0.52 -0.99 0.63 0.52 0.99 -0.63 0.52 0.99 0.63 r 1 1 0 s 1 1 1
!svs add wheel world v -0.68 -0.63 -0.44 -0.68 -0.63 0.44 -0.68 0.63 -0.44 -0.68 0.63 0.44 0.68 -0.63 -0.44 0.68 -0.63 0.44 0.68 0.63 -0.44 0.68 0.63 0.44 p 2.75 -1.61 0
!svs tag add hero colour blue
!svs tag add hero kind blue
!svs tag add crate colour blue
!svs tag add spot colour blue
run 2
print -d 7 c3
!svs change lamp p -1 -0.25 3.0
!svs change spot p -3 2 -3.75
!svs change wheel p -2.5 3.55 -2 r -1.26 0 1.5708
!svs delete wheel
run 1
print -d 7 c3
!svs tag delete spot colour
!svs change hero p -3.25 2.97 -4 r 2.63 0 0 s 2.92 0.96 0.5
!svs add wall world v -0.88 -1.24 -1.01 -0.88 -1.24 1.01 -0.88 1.24 -1.01 -0.88 1.24 1.01 0.88 -1.24 -1.01 0.88 -1.24 1.01 0.88 1.24 -1.01 0.88 1.24 1.01 p 2 2.65 -0.5
run 1
print -d 7 c3
!svs? list-all-objs
