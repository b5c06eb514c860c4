svs --enable
source agent.soar
run 1
!svs add lamp world b 0.5 p 1.75 -2.91 1.0 r 0 1.5708 1.5708
!svs add door world v -1.25 -0.22 -1.22 -1.25 -0.22 1.22 -1.25 0.22 -1.22 -1.25 0.22 1.22 1.25 -0.22 -1.22 1.25 -0.22 1.22 1.25 0.22 -1.22 1.25 0.22 1.22 p -3 3.38 -3
!svs add wall world p 3.82 4 -3.91
!svs add spot world v 0 0 0 p 1.25 -1 2.52 s 1 1 1
!svs add crate world v 0.21 1 0.75 -0.5 0.25 0.64 -0.25 1 0.25 0.27 1 -0.39 -1.0 0.25 -0.75 1 0.47 0.25 0.75 0.87 -1 0 1 0.45 0 0 -0.04 -0.83 -1 -0.25 0.75 -1 -1 -0.75 -0.75 -1.0 p 4 1.5 -3.0
!svs add hero world v -1 0.14 -0.5 1 1 0.5 0.87 1 1 0.75 0 -1 -1 1 0 -1.0 0.76 -0.25 p -2.49 2.58 2.41 s 1 1 1
!svs add tree wall v 0.4 -0.75 -0.75 1 -1 0 p 2 -0.75 -1.05 s 1 1 1
!svs tag add lamp colour red
!svs tag add door kind red
!svs tag add wall kind red
!svs tag add spot kind red
!svs tag add tree colour red
!svs tag add tree kind blue
run 2
print -d 7 c3
!svs change hero
!svs change tree p -4.0 -1.75 -1.07
!svs delete spot
run 2
print -d 7 c3
!svs change tree s 1 1 1
!svs change door p 3.34 1 -2.53
!svs change tree p 3.53 0.28 -1.25 r 0 0 0
!svs change door p -3 3 -1 s 1 1 0.5
run 2
print -d 7 c3
!svs change wall s 0.5 0.5 0.5
!svs change hero p -0.69 0.0 -2.0
!svs change crate p -3 1 -4 r 1.5708 0 0.5 s 1 1 1
!svs change hero p -1 -4.0 -0.59 r 0.5 1 1.5708 s 2.67 2.67 2.67
run 1
print -d 7 c3
!svs? list-all-objs
