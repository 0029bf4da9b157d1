# picture of increments
