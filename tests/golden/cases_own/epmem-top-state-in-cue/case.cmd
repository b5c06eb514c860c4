epmem --enable
sp {sub (state <s> ^superstate <ss>) (<ss> ^superstate nil) --> (<ss> ^seen <s>)}
sp {q (state <s> ^superstate nil ^io.input-link.ask 1 ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^seen.superstate <x>)}
sp {ask2 (state <s> ^superstate nil ^io.input-link.ask 2 ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^seen.superstate <q>)}
sp {ask3 (state <s> ^superstate nil ^io.input-link.ask 3 ^epmem.command <c>) --> (<c> ^query <q>)  (<q> ^seen <a> ^io <b>) (<a> ^superstate <b>)}
sp {ask4 (state <s> ^superstate nil ^io.input-link.ask 4 ^epmem.command <c>) --> (<c> ^query <q>)  (<q> ^seen <a>) (<a> ^superstate <b>) (<b> ^type state)}
trace 0
!wme w il int ask 0
run 3
!update w 1
run 2
print e1 -d 3
!update w 2
run 2
print e1 -d 3
!update w 3
run 2
print e1 -d 3
!update w 4
run 2
print e1 -d 3
