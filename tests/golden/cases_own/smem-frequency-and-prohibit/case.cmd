source agent.soar
!wme a il string ask a
run 3
print @
!destroy a
!wme n il string not a
run 2
print @
!destroy n
!wme a il string ask a
run 2
print @
!destroy a
!wme n il string not b
run 2
print @
