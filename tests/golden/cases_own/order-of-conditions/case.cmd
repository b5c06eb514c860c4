source agent.soar
print --internal scan
print --internal copy
print --internal larger
print --internal narrow
print --internal apart
print --internal itself
print --internal ring
print --internal denied
production optimize-attribute source 20
sp {copy (state <s> ^source <from> ^target <to>) (<from> ^<name> <what>) (<what> ^part <part>) (<name> ^copied yes) --> (<to> ^<name> <what>)}
print --internal copy
