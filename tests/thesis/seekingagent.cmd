source agent.soar
trace 1
!wme distance il float distance 100.0
!til-output
!commands
!complete
!update distance 50.5
!til-output
!commands
!complete
!update distance 2.5
!til-output
!commands
!complete
!update distance 2.5
!til-output
!commands
!complete
!update distance 80.0
!til-output
!commands
!complete
!update distance 3.0
!til-output
!commands
print --stack
print --depth 2 i3
