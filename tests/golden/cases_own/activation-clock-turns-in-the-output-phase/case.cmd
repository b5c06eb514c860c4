source agent.soar
watch 0
run 2 -d
print -i c1 -d 1
print -i s1 -d 2
run 1 -p
print -i s1 -d 2
run 1 -p
print -i s1 -d 2
run 1 -p
print -i s1 -d 2
run 1 -p
print -i s1 -d 2
run 1 -p
print -i s1 -d 2
watch 5
run 5 -d
watch 0
print -i s1 -d 2
print -d 4 e1
run 2 -d
print -i s1 -d 2
