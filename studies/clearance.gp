# picture of clearance
