svs --enable
source agent.soar
run 1
!svs add crate world b 2 p 2 -2.25 0 r 0 0 1
!svs add wheel world v -1.21 -1.09 -0.86 -1.21 -1.09 0.86 -1.21 1.09 -0.86 -1.21 1.09 0.86 1.21 -1.09 -0.86 1.21 -1.09 0.86 1.21 1.09 -0.86 1.21 1.09 0.86 p 1 1.5 -2.94 r 0 0 1
!svs tag add crate colour red
!svs tag add wheel kind blue
run 2
print -d 7 c3
!svs change wheel p 0.5 -2 2.75
!svs delete wheel
!svs add cart world b 2.0 p -1.15 3 4.0 r 0.5 0 0
run 1
print -d 7 c3
!svs tag add cart colour blue
!svs add wheel world p -2.0 -1.25 -2
!svs change crate p -2.75 2.22 -0.58 r 1 1.5708 1.79
!svs change wheel p -3.0 -1 2 r 0.5 0 0
run 1
print -d 7 c3
!svs? list-all-objs
