smem --set learning on
watch 0
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> <z>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> ^depth 2)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^link-to-ltm yes ^prohibit <y>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> ^link-to-ltm yes)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <x>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> ^neg-query <x>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> ^query <x>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 4 ^x <x> ^y <y> ^z <z> ^smem.command <c>) --> (<c> ^prohibit <y> ^store <x>)}
run 8
print -d 2 r3
print c2
excise --all
init-soar
