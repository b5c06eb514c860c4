source agent.soar
trace 0
!wme b0 il id box b0
!wme t0 b0 int tag 0
!wme k0 b0 string kind box
!wme s0 b0 int size 1
!wme c0 b0 string colour r
!wme b1 il id box b1
!wme t1 b1 int tag 1
!wme k1 b1 string kind box
!wme s1 b1 int size 1
!wme c1 b1 string colour g
!wme o1 b1 id on o1
!wme ok1 o1 string kind box
!wme ot1 o1 int tag 11
!wme b2 il id box b2
!wme t2 b2 int tag 2
!wme k2 b2 string kind box
!wme s2 b2 int size 1
!wme c2 b2 string colour g
!wme o2 b2 id on o2
!wme ok2 o2 string kind box
!wme ot2 o2 int tag 12
!wme b3 il id box b3
!wme t3 b3 int tag 3
!wme k3 b3 string kind box
!wme s3 b3 int size 2
!wme c3 b3 string colour r
!wme o3 b3 id on o3
!wme ok3 o3 string kind box
!wme ot3 o3 int tag 13
!wme b4 il id box b4
!wme t4 b4 int tag 4
!wme k4 b4 string kind box
!wme s4 b4 int size 2
!wme c4 b4 string colour g
!wme o4 b4 id on o4
!wme ok4 o4 string kind box
!wme ot4 o4 int tag 14
run 2
!update s2 2
!update c1 r
run 1
!wme q il int ask 1
run 2
print e1 --depth 4
