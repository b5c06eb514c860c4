svs --enable
source agent.soar
!svs add door world v -1.28 -0.9 -0.25 -1.28 -0.9 0.25 -1.28 0.9 -0.25 -1.28 0.9 0.25 1.28 -0.9 -0.25 1.28 -0.9 0.25 1.28 0.9 -0.25 1.28 0.9 0.25 p -2.25 -2.5 -4 s 1 1 1
!svs add spot world v 0.25 -0.75 0.09 -1 -0.49 -0.75 1 -0.62 0.11 0.0 -0.5 1 1 0.25 1 0.35 -1 0.8 0.75 0 -0.02 -1 1.0 -1 p -2.0 3.25 0.51 r 0 0.5 0
!svs add crate world v 0 -0.88 -0.75 1 -1.0 0 0.5 -1 0 -0.42 -0.98 -0.03 -1.0 1 1 -0.5 0 -0.3 0 0 0.71 -1.0 0 1 -0.25 -0.5 0.49 1 0.11 -0.75 -1 -1 0 -0.75 0 1 p -1.75 -4 -1.25 r 0.5 0 1.5708 s 0.5 0.5 0.5
!svs add lamp world p 1 -3.0 1.5
!svs add cart world v 0.94 0 0.06 1 1.0 0.31 0.25 0.0 0.5 1 -0.25 1 0.22 -1 -1 0.84 -1 -1 0.0 0.46 -0.56 1 0.44 -1 0.97 0.5 -0.39 1 -1.0 -0.94 p 3 0 3.7 r 1.59 0 0
!svs add wall world v -0.3 1.0 0.75 -0.75 0.5 -1 0 -0.25 0.58 1 -1 -0.75 -0.25 -0.17 0 1 0 -1.0 0.88 0.5 0 0 -0.75 0 s 0.5 2.12 1
!svs add ball lamp v -0.79 -1.24 -0.91 -0.79 -1.24 0.91 -0.79 1.24 -0.91 -0.79 1.24 0.91 0.79 -1.24 -0.91 0.79 -1.24 0.91 0.79 1.24 -0.91 0.79 1.24 0.91 p 2.01 0.04 -1.94 r 0.5 0 0 s 1.67 1.67 1.67
!svs add tree world p 2.5 -2.48 -0.25 r 0 1.5708 0 s 1 1.76 1
!svs add hero tree b 1 p -1.39 -0.94 -0.25
!svs tag add spot colour red
!svs tag add crate colour red
!svs tag add crate kind blue
!svs tag add cart colour red
!svs tag add wall kind red
!svs tag add ball kind red
!svs tag add hero colour blue
run 2
print -d 7 c3
!svs change wall p -2.5 -2 4
!svs change ball r -2.55 1 1.5708
run 1
print -d 7 c3
!svs change hero p 3.37 -1 -2
!svs change hero p -2.32 0.62 0.25
!svs change ball p -3.8 -1 4.0
!svs delete cart
run 1
print -d 7 c3
!svs change wall
!svs change crate p -2 -3.28 3.25 r 1.5708 0 0
run 2
print -d 7 c3
!svs? list-all-objs
