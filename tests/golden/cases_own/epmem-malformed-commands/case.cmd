epmem --enable
sp {ask- (state <s> ^superstate nil ^io.input-link.ask 1 ^epmem.command <c>) --> (<c> ^query <q> ^query <r>) (<q> ^type state) (<r> ^type state)}
sp {ask-2 (state <s> ^superstate nil ^io.input-link.ask 2 ^epmem.command <c>) --> (<c> ^query <q>)}
sp {ask-3 (state <s> ^superstate nil ^io.input-link.ask 3 ^epmem.command <c>) --> (<c> ^query <q> ^before 0) (<q> ^type state)}
sp {ask-4 (state <s> ^superstate nil ^io.input-link.ask 4 ^epmem.command <c>) --> (<c> ^query <q> ^after 100) (<q> ^type state)}
sp {ask-5 (state <s> ^superstate nil ^io.input-link.ask 5 ^epmem.command <c>) --> (<c> ^query <q> ^neg-query <n>) (<q> ^none 1) (<n> ^none 2)}
sp {ask-6 (state <s> ^superstate nil ^io.input-link.ask 6 ^epmem.command <c>) --> (<c> ^query <q> ^before 3.0) (<q> ^type state)}
sp {ask-7 (state <s> ^superstate nil ^io.input-link.ask 7 ^epmem.command <c>) --> (<c> ^query <q> ^prohibit 0 -1) (<q> ^type state)}
sp {ask-8 (state <s> ^superstate nil ^io.input-link.ask 8 ^epmem.command <c>) --> (<c> ^retrieve 1 2)}
sp {ask-9 (state <s> ^superstate nil ^io.input-link.ask 9 ^epmem.command <c>) --> (<c> ^query <q> ^before 3 4) (<q> ^type state)}
sp {ask-10 (state <s> ^superstate nil ^io.input-link.ask 10 ^epmem.command <c>) --> (<c> ^query <q> ^neg-query <n> <m>) (<q> ^type state) (<n> ^none 2) (<m> ^none 2)}
sp {ask-11 (state <s> ^superstate nil ^io.input-link.ask 11 ^epmem.command <c>) --> (<c> ^query <q> ^neg-query <n>) (<q> ^type state) (<n>  ^type state)}
sp {ask-12 (state <s> ^superstate nil ^io.input-link.ask 12 ^epmem.command <c>) --> (<c> ^query <q> ^after -1) (<q> ^type state)}
trace 0
!wme w il int ask 0
run 1
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
!update w 5
run 2
print e1 -d 3
init-soar
!update w 6
run 2
print e1 -d 3
!update w 7
run 2
print e1 -d 3
!update w 8
run 2
print e1 -d 3
!update w 9
run 2
print e1 -d 3
!update w 10
run 2
print e1 -d 3
!update w 11
run 2
print e1 -d 3
!update w 12
run 2
print e1 -d 3
