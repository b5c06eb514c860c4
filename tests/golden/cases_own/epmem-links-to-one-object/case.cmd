epmem --enable
sp {init (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name init)}
sp {rule-i-2 (state <s> ^operator.name init) --> (<s> ^w <w>) (<w> ^thing <t> ^box <t>) (<t> ^kind x)}
sp {q (state <s> ^superstate nil ^io.input-link.ask two ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^w <w>) (<w> ^thing <a> ^box <b>) (<a> ^kind x) (<b> ^kind x)}
sp {rule-q-2 (state <s> ^superstate nil ^io.input-link.ask one ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^w <w>) (<w> ^thing <a> ^box <a>) (<a> ^kind x)}
sp {rule-q-3 (state <s> ^superstate nil ^io.input-link.ask leaf ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^w <w>) (<w> ^thing <a> ^box <b>)}
trace 0
!wme w il string ask none
run 3
epmem --print 3
!update w two
run 2
print e1 -d 6
!update w one
run 2
print e1 -d 3
!update w leaf
run 2
print e1 -d 3
