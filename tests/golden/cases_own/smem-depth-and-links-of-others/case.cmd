smem --set learning on
watch 0
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^depth 2 ^store <y>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^store <y> ^depth 2)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^depth 2 ^store-new <y>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^link-to-ltm yes ^store <y>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^store <y> ^link-to-ltm yes)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^link-to-new-ltm yes ^query <x>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^query <x> ^link-to-new-ltm yes)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^link-to-new-ltm no ^retrieve <x>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^link-to-ltm yes ^link-to-new-ltm yes ^store-new <y>)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^store-new <y> ^link-to-ltm no ^link-to-new-ltm yes)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^depth 2)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
source agent.soar
sp {ask*now (state <s> ^superstate nil ^operator.name ask ^beat 2 ^x <x> ^y <y> ^smem.command <c>) --> (<c> ^link-to-ltm yes ^depth 3)}
run 4
print -d 2 r3
print c2
excise --all
init-soar
