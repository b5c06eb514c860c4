source agent.soar
trace 1
trace --epmem
!wme l il string light green
!wme a il string alarm off
!wme d il string door open
!wme c il int crew 4
!wme b1 il id box b1
!wme b1s b1 int size 3
!wme b1c b1 string colour red
run 1
!update d shut
!update b1c blue
run 1
!wme b2 il id box b2
!wme b2c b2 string colour red
run 2
!update l red
!update a on
run 1
!wme q il string ask parts
run 2
!update q whole
run 2
epmem --set graph-match off
!update q without
run 2
epmem --set graph-match on
!update q bounded
run 2
!update q never
run 2
!update q object
run 2
print e1 --depth 2
trace --epmem remove
!update q parts
run 2
watch --epmem
!update q whole
run 2
