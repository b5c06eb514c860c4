source agent.soar
!wme a il id thing
!wme a1 a string kind b
run 6
sp {ask*one (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^io.input-link.thing.kind b)}
run 2
epmem --stats queries
epmem --stats qry-ret
epmem --stats qry-card
excise ask*one
sp {ask*two (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q>) (<q> ^io.input-link.thing.kind nothing)}
run 2
epmem --stats queries
epmem --stats qry-ret
epmem --stats qry-card
excise ask*two
sp {ask*three (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query <q> ^before 3 ^after 3) (<q> ^io.input-link.thing.kind b)}
run 2
epmem --stats queries
epmem --stats qry-ret
epmem --stats qry-card
