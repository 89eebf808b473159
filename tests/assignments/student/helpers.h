// Your own helper functions, if you want any. Every file of the project can call them. Mark each `inline`.
// The grader takes this file along with the functions of the tasks; no line may begin with # but the next one.
#pragma once
