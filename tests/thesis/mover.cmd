source agent.soar
trace 1
!wme front il string front empty
!til-output
!commands
!complete
!update front empty
!til-output
!commands
!complete
!update front empty
!til-output
!commands
!complete
!update front wall
!til-output
!commands
!complete
!update front wall
!til-output
!commands
!complete
print --depth 2 i3
print --stack
print s1
stats --decision
