svs --enable
source agent.soar
!svs add cart world v 0 0 0 p 3.5 -3 -3.5 r 0 1.5708 0 s 0.5 0.5 0.5
!svs add hero world b 0.5 p -1.95 0.66 -1 s 2 2 2
!svs add wheel world b 1.0 p 2.25 -4.0 1.67 r 0 1 1.5708
!svs add lamp world v -0.47 -0.78 -1.01 -0.47 -0.78 1.01 -0.47 0.78 -1.01 -0.47 0.78 1.01 0.47 -0.78 -1.01 0.47 -0.78 1.01 0.47 0.78 -1.01 0.47 0.78 1.01 p -0.67 2.63 -3.74 r 2.08 1 0
!svs add crate world b 1 p 0.5 -0.75 -3 r 1 0 -1.02 s 1.53 1.53 1.53
!svs add spot world v 0 0 0 p -1 2.85 4 r 0 0 1.5708
!svs add tree world v 0.5 0.69 0.5 0.58 -0.38 -0.28 -1.0 0 -1 0.0 0 -1 0.88 0 0.42 1.0 -0.19 -0.75 -0.69 1 -0.37 p 0.25 -2.75 0 s 2 0.22 1
!svs tag add hero colour blue
!svs tag add hero kind blue
!svs tag add crate kind red
!svs tag add spot kind blue
!svs tag add tree kind red
run 2
print -d 7 c3
!svs change hero p 3.75 0.37 -4 r -0.3 1.5708 1
!svs change lamp p -4 2.5 3.0 r 0 1.5708 0
run 1
print -d 7 c3
!svs change lamp r 0.5 1 0.5 s 2.67 1 1
!svs delete lamp
!svs tag add wheel kind red
!svs change cart p -4 0.62 4 r 0 0 1
run 1
print -d 7 c3
!svs? list-all-objs
