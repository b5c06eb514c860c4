epmem --enable
sp {sub (state <s> ^superstate <ss>) (<ss> ^superstate nil) --> (<ss> ^seen <s>)}
sp {ask4 (state <s> ^superstate nil ^io.input-link.ask 4 ^epmem.command <c>) --> (<c> ^query <q>)  (<q> ^seen <a>) (<a> ^superstate <b>) (<b> ^type state)}
trace 0
!wme w il int ask 0
run 3
!update w 4
run 2
print e1 -d 5
