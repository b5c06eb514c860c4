source agent.soar
run 1.5
run 1x
run x
run -1
run 0
run -e -d 2
run -p -i e 2
run -p -i p 2
run -e -i p 2
run -d 1 -i o
run 1 2
print s1
