source agent.soar
print
source -v agent.soar
source -d parts/list.soar
source nowhere/list.soar
source parts/nothing.soar
pushd parts
source deep/leaf.soar
popd
run 1
print s1
