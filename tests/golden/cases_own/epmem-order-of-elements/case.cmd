source agent.soar
!wme a il id thing
!wme a1 a string kind b
!wme a2 a string kind a
!wme a3 a int n 2
!wme b il id thing
!wme b1 b string kind c
!wme b2 b string kind b
run 1
!wme a4 a string kind c
!wme a5 a string hue a
!wme c il id box
!wme d il id box
!wme d1 d string hue c
!wme c1 c string hue d
!wme c2 c string hue b
run 1
!destroy a1
run 1
!wme a6 a string kind b
!wme e il id thing
!wme e1 e string kind e
run 1
!wme s il int step 4
run 2
print --internal R2 -d 6
!destroy s
!wme s il int step 1
run 2
print --internal R2 -d 6
!destroy s
!wme s il int step 2
run 2
print --internal R2 -d 2
