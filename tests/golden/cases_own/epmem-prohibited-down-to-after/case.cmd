source agent.soar
trace 1
trace --epmem
!wme l il string light green
!wme d il string door open
run 2
!update d shut
run 2
!update l red
run 2
!update l green
run 2
!wme b il int before 9
!wme a il int after 6
!wme p1 il int prohibit 7
!wme p2 il int prohibit 8
!wme q il int case 1
run 2
print e1 --depth 2
!wme p3 il int prohibit 6
!update q 2
run 2
print e1 --depth 2
!destroy a
!wme a il int after 7
!destroy p1
!update q 3
run 2
print e1 --depth 2
!wme d2 il string door-too yes
!update q 4
run 2
print e1 --depth 2
!destroy b
!destroy a
!wme b il int before 5
!wme a il int after 3
!wme p4 il int prohibit 4
!update q 5
run 2
print e1 --depth 2
!wme p5 il int prohibit 3
!update q 6
run 2
print e1 --depth 2
!destroy d2
!update q 7
run 2
print e1 --depth 2
!wme p6 il int prohibit 2
!wme p7 il int prohibit 1
!update q 8
run 2
print e1 --depth 2
