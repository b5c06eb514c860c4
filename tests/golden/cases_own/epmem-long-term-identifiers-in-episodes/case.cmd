source agent.soar
watch 0
run 6
print -d 5 e1
print -d 4 s1
epmem --print 3
epmem --print 4
