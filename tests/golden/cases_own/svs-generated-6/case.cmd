svs --enable
source agent.soar
!svs add spot world v -0.74 -1.41 -0.73 -0.74 -1.41 0.73 -0.74 1.41 -0.73 -0.74 1.41 0.73 0.74 -1.41 -0.73 0.74 -1.41 0.73 0.74 1.41 -0.73 0.74 1.41 0.73 p 3.75 1.5 -2.5
!svs add crate world b 1 p 0.31 2.17 -2.0 r 0.5 1 0
!svs add wheel world v -0.36 -1.08 -0.32 -0.36 -1.08 0.32 -0.36 1.08 -0.32 -0.36 1.08 0.32 0.36 -1.08 -0.32 0.36 -1.08 0.32 0.36 1.08 -0.32 0.36 1.08 0.32 p 3.57 4 -1 r 0.5 0 1.5708
!svs add ball world b 1.61 p -0.75 0.95 -2.5 r 0 0 0 s 1 1 1
!svs add door world v -1.09 -1.17 -0.78 -1.09 -1.17 0.78 -1.09 1.17 -0.78 -1.09 1.17 0.78 1.09 -1.17 -0.78 1.09 -1.17 0.78 1.09 1.17 -0.78 1.09 1.17 0.78 p 0.75 -2.75 4 r 0 1 0.5 s 1 1 1
!svs add lamp world v -1.16 -0.54 -0.45 -1.16 -0.54 0.45 -1.16 0.54 -0.45 -1.16 0.54 0.45 1.16 -0.54 -0.45 1.16 -0.54 0.45 1.16 0.54 -0.45 1.16 0.54 0.45 p 3.25 3.52 0
!svs add wall world v 0 0 0 p -2.23 -0.09 0.65
!svs add cart world p 0 4.0 3.75 r 0.39 1.5708 0.5 s 2 0.5 2
!svs add tree world b 0.75 p 1 -0.24 -3 r 0.11 0 0.5 s 0.5 0.5 0.5
!svs tag add spot colour red
!svs tag add wheel kind blue
!svs tag add ball kind blue
!svs tag add door kind blue
!svs tag add lamp kind red
!svs tag add wall colour red
!svs tag add wall kind blue
!svs tag add tree colour blue
run 2
print -d 7 c3
!svs change cart s 2 2 0.5
!svs tag change spot colour red
!svs tag change crate kind blue
run 1
print -d 7 c3
!svs add hero world b 1.75 p 2.57 -0.48 -2.2 r 0.5 0 1 s 1 1 1
!svs delete spot
run 1
print -d 7 c3
!svs? list-all-objs
