epmem --enable
sp {sub (state <s> ^superstate <ss>) (<ss> ^superstate nil) --> (<ss> ^seen <s>)}
sp {ask3 (state <s> ^superstate nil ^io.input-link.ask 3 ^epmem.command <c>) --> (<c> ^query <q>)  (<q> ^seen <a> ^io <b>) (<a> ^superstate <b>)}
trace 0
!wme w il int ask 0
run 3
!update w 3
run 2
print e1 -d 5
