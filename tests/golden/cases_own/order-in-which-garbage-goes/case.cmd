# what no link holds any more goes in the order in which it lost its first link, circles come last and from their far end
source agent.soar
run 1
watch 5
run 1
print --depth 5 s1
