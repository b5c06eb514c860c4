source agent.soar
run 1
run 1
init-soar
run 3
init-soar
run
init-soar
run -p 6
init-soar
run -e 7
init-soar
run -o 2
init-soar
!run 3
init-soar
!run-self 6 phase
init-soar
!run-all 6 phase
print s1
