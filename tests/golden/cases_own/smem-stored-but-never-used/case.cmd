smem --set activation-mode frequency
source agent.soar
trace 0
run 5
print @
run 3
print @
init-soar
smem --clear
excise --all
smem --set activation-mode recency
source agent.soar
run 5
print @
run 3
print @
