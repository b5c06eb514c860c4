epmem --enable
sp {g (state <s> ^superstate nil ^io.input-link.go <g> ^epmem.command <c>) (<g> ^kind retrieve ^n <n>) --> (<c> ^retrieve <n>)}
sp {n (state <s> ^superstate nil ^io.input-link.go <g> ^epmem.command <c>) (<g> ^kind next) --> (<c> ^next <g>)}
sp {p (state <s> ^superstate nil ^io.input-link.go <g> ^epmem.command <c>) (<g> ^kind previous) --> (<c> ^previous <g>)}
sp {q (state <s> ^superstate nil ^io.input-link.go <g> ^epmem.command <c>) (<g> ^kind query) --> (<c> ^query <q>) (<q> ^io.input-link.light red)}
trace 0
!wme l il string light green
run 3
!wme g1 il id go
!wme k1 g1 string kind next
run 2
print e1 -d 2
!destroy g1
!wme g2 il id go
!wme k2 g2 string kind retrieve
!wme n2 g2 int n 1
run 2
print e1 -d 2
!destroy g2
!wme g3 il id go
!wme k3 g3 string kind previous
run 2
print e1 -d 2
!destroy g3
!wme g4 il id go
!wme k4 g4 string kind next
run 2
print e1 -d 2
!destroy g4
!wme g5 il id go
!wme k5 g5 string kind retrieve
!wme n5 g5 int n 2
run 2
!destroy g5
!wme g6 il id go
!wme k6 g6 string kind query
run 2
print e1 -d 2
!destroy g6
!wme g7 il id go
!wme k7 g7 string kind next
run 2
print e1 -d 2
