chunk except
watch 0
source agent.soar
run 9
print --full --chunks
excise --chunks
init-soar
run 9
print --full --chunks
