source agent.soar
soar stop-phase input
soar stop-phase propose
soar stop-phase proposal
soar stop-phase decide
soar stop-phase decision
soar stop-phase apply
soar stop-phase output
soar stop-phase in
soar stop-phase
set-stop-phase -i
set-stop-phase -p
set-stop-phase -d
set-stop-phase --decide
set-stop-phase --before
set-stop-phase -B -o
soar stop-phase
run 2
soar stop-phase decision
run 1
run 1
