epmem --set learning on
epmem --set trigger dc
epmem --set graph-match on
watch 0
source agent.soar
run 4
sp {ask*0 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b>) (<a> ^to <x> ^by <y>) (<b> ^to <y> ^by <x>) (<x> ^load wood) (<y> ^load tin)}
run 1
print -d 2 r2
excise ask*0
run 1
sp {ask*1 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b>) (<a> ^to <x> ^by <y>) (<b> ^to <x> ^by <y>) (<x> ^load wood) (<y> ^load tin)}
run 1
print -d 2 r2
excise ask*1
run 1
sp {ask*2 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b>) (<a> ^to <x> ^by <y>) (<b> ^to <y> ^by <x>) (<x> ^load tin)}
run 1
print -d 2 r2
excise ask*2
run 1
sp {ask*3 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b>) (<a> ^to <x>) (<b> ^by <x>)  (<x> ^load wood)}
run 1
print -d 2 r2
excise ask*3
run 1
sp {ask*4 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b>) (<a> ^to <x>) (<b> ^to <x>)  (<x> ^load wood)}
run 1
print -d 2 r2
excise ask*4
run 1
sp {ask*5 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^other <b>) (<a> ^to <x> ^by <y>) (<b> ^to <x> ^by <x>)}
run 1
print -d 2 r2
excise ask*5
run 1
sp {ask*6 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <b> ^other <c>) (<a> ^to <x> ^by <y>) (<b> ^to <y> ^by <x>) (<c> ^to <x> ^by <x>)}
run 1
print -d 2 r2
excise ask*6
run 1
sp {ask*7 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^other <b>) (<b> ^to <x> ^by <y>) (<x> ^load wood) (<y> ^load tin)}
run 1
print -d 2 r2
excise ask*7
run 1
sp {ask*8 (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^left <a> ^right <a>) (<a> ^to <x>)}
run 1
print -d 2 r2
excise ask*8
run 1
